//! A figure as SVG: axes with names, lines that are told apart by colour and by dashes, marks.
//!
//! The colours are those of the page around it: the text colour, and variables with a value for light and for dark. The
//! plotting library knows fixed colours only, so it is given codes, which are replaced.

use plotters::prelude::*;

use crate::{Error, Result};

/// The size of the canvas. Places are whole numbers, so it is larger than what is shown; not so large that the names would
/// be illegible on a phone.
const SIZE: (u32, u32) = (860, 620);
/// What the axes take of the width and of the height.
const AROUND: (u32, u32) = (168, 178);

/// How a line looks: a colour of the page, and dashes.
const LOOKS: [(&str, &str, &str); 5] = [
    ("#0A0001", "var(--plot-1)", "none"),
    ("#0A0002", "var(--plot-2)", "18 10"),
    ("#0A0003", "var(--plot-3)", "4 9"),
    ("#0A0004", "var(--plot-4)", "24 8 4 8"),
    ("#0A0005", "var(--plot-5)", "10 6"),
];

/// A line of a figure, and its name in the legend; a line without a name has none.
pub(super) struct Curve {
    pub name: String,
    /// The look, from 0.
    pub look: usize,
    pub points: Vec<(f64, f64)>,
}

/// What is drawn.
pub(super) struct Figure {
    pub title: String,
    pub axes: [String; 2],
    pub curves: Vec<Curve>,
    /// Points that are marked with a ring.
    pub marks: Vec<(f64, f64)>,
    /// Whether both axes have the same scale, as for something in space.
    pub is_square: bool,
}

impl Figure {
    /// The figure as SVG.
    ///
    /// # Errors
    /// When there is nothing finite to draw.
    pub fn svg(&self) -> Result<String> {
        let points = self.curves.iter().flat_map(|curve| &curve.points).chain(&self.marks);
        let finite = || points.clone().filter(|(x, y)| x.is_finite() && y.is_finite());
        let nothing = || {
            Error::new("there is nothing to draw, because no computed value is finite")
                .help("choose another starting state with --set")
        };
        finite().next().ok_or_else(nothing)?;
        let range = |of: fn(&(f64, f64)) -> f64| {
            let (low, high) = finite().map(of).fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x), high.max(x)));
            let margin = if high > low { 0.05 * (high - low) } else { 1.0_f64.max(high.abs()) };
            (low - margin, high + margin)
        };
        let (mut x, mut y) = (range(|p| p.0), range(|p| p.1));
        if self.is_square {
            let (low, high) = (x.0.min(y.0), x.1.max(y.1));
            let ratio = f64::from(SIZE.0 - AROUND.0) / f64::from(SIZE.1 - AROUND.1);
            let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
            (x, y) = ((middle - ratio * half, middle + ratio * half), (low, high));
        }
        let mut svg = String::new();
        self.draw(&mut svg, x, y).map_err(|error| Error::new(format!("the picture cannot be drawn: {error}")))?;
        Ok(self.coloured(&svg))
    }

    fn draw(
        &self,
        svg: &mut String,
        x: (f64, f64),
        y: (f64, f64),
    ) -> std::result::Result<(), Box<dyn std::error::Error>> {
        let ink = RGBColor(1, 1, 1);
        let soft = RGBColor(2, 2, 2);
        let root = SVGBackend::with_string(svg, SIZE).into_drawing_area();
        let font = |size: u32| ("sans-serif", size).into_font().color(&ink);
        let mut chart = ChartBuilder::on(&root)
            .caption(&self.title, font(32))
            .margin(16)
            .x_label_area_size(88)
            .y_label_area_size(120)
            .build_cartesian_2d(x.0..x.1, y.0..y.1)?;
        chart
            .configure_mesh()
            .x_desc(&self.axes[0])
            .y_desc(&self.axes[1])
            .label_style(font(30))
            .axis_desc_style(font(32))
            .axis_style(ink)
            .bold_line_style(soft)
            .light_line_style(TRANSPARENT)
            .x_labels(6)
            .y_labels(6)
            .draw()?;
        for curve in &self.curves {
            let (code, ..) = LOOKS[curve.look % LOOKS.len()];
            let style = colour(code).stroke_width(4);
            let finite = curve.points.iter().copied().filter(|(x, y)| x.is_finite() && y.is_finite());
            let drawn = chart.draw_series(LineSeries::new(finite, style))?;
            if !curve.name.is_empty() {
                drawn.label(&curve.name).legend(move |(x, y)| PathElement::new([(x, y), (x + 60, y)], style));
            }
        }
        chart.draw_series(self.marks.iter().map(|&at| Circle::new(at, 10, ink.stroke_width(3))))?;
        if self.curves.iter().any(|curve| !curve.name.is_empty()) {
            chart
                .configure_series_labels()
                .position(self.free_corner(x, y))
                .legend_area_size(70)
                .margin(12)
                .background_style(RGBColor(3, 3, 3).mix(0.85))
                .border_style(soft)
                .label_font(font(30))
                .draw()?;
        }
        root.present()?;
        drop(chart);
        drop(root);
        Ok(())
    }

    /// The corner of the plane that most points stay away from.
    fn free_corner(&self, x: (f64, f64), y: (f64, f64)) -> SeriesLabelPosition {
        use SeriesLabelPosition::{LowerLeft, LowerRight, UpperLeft, UpperRight};
        let share = |value: f64, (low, high): (f64, f64)| (value - low) / (high - low);
        let within = |right: bool, upper: bool| {
            let points = self.curves.iter().flat_map(|curve| &curve.points).chain(&self.marks);
            let is_there = |&&(a, b): &&(f64, f64)| {
                let (a, b) = (share(a, x), share(b, y));
                (if right { a > 0.62 } else { a < 0.38 }) && (if upper { b > 0.6 } else { b < 0.4 })
            };
            points.filter(is_there).count()
        };
        let corners =
            [(UpperRight, true, true), (UpperLeft, false, true), (LowerRight, true, false), (LowerLeft, false, false)];
        let free = corners.into_iter().min_by_key(|(_, right, upper)| within(*right, *upper));
        free.map_or(UpperRight, |(corner, ..)| corner)
    }

    /// The colours of the page in place of the codes.
    fn coloured(&self, svg: &str) -> String {
        let mut svg = svg
            .replace("\"#010101\"", "\"currentColor\"")
            .replace("\"#020202\"", "\"var(--plot-soft)\"")
            .replace("\"#030303\"", "\"var(--plot-paper)\"");
        for (code, colour, dashes) in LOOKS {
            svg = svg
                .replace(&format!("stroke=\"{code}\""), &format!("stroke=\"{colour}\" stroke-dasharray=\"{dashes}\""));
        }
        let head = format!(
            "<svg class=\"onshell-plot\" role=\"img\" aria-label=\"{}\" viewBox=\"0 0 {} {}\" style=\"max-width:100%\" ",
            escaped(&self.title),
            SIZE.0,
            SIZE.1
        );
        let body = svg.split_once("<svg").map_or("", |(_, rest)| rest);
        let body = body.split_once('>').map_or("", |(_, rest)| rest);
        format!("{head}xmlns=\"http://www.w3.org/2000/svg\">\n<style>{STYLE}</style>\n{}\n", body.trim())
    }
}

const STYLE: &str = ".onshell-plot{color:#1c1c1e;--plot-paper:#fdfdfb;--plot-soft:#c9c9c4;--plot-1:#0b4f9e;--plot-2:#a3400a;\
--plot-3:#17613a;--plot-4:#7a1f7a;--plot-5:#6b5a00}@media (prefers-color-scheme: dark){.onshell-plot{color:#ececf0;\
--plot-paper:#17181b;--plot-soft:#4a4b52;--plot-1:#8ec2ff;--plot-2:#ffb287;--plot-3:#7fd6a4;--plot-4:#e3a0e3;--plot-5:#e0cf70}}";

fn colour(code: &str) -> RGBColor {
    let part = |at: usize| u8::from_str_radix(code.get(at..at + 2).unwrap_or_default(), 16).unwrap_or_default();
    RGBColor(part(1), part(3), part(5))
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}
