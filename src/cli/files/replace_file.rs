//! A text file that is replaced as a whole or not at all.
//!
//! The new text is written to a file beside the old one, which then takes its place. So a disk that is full, or a program
//! that is stopped, leaves the old text as it was. The new file has the permissions of the old one; a link still leads
//! to it.

use std::io::Write;
use std::path::Path;

use crate::{Error, Result};

/// Replaces the bytes of the file at `path`, if they still are `before`.
///
/// # Errors
/// When the file has changed, when its folder or it cannot be written, when there is no room. The file is then unchanged.
pub(crate) fn replace(path: &Path, before: &[u8], after: &[u8]) -> Result<()> {
    let shown = path.display();
    let failed = |error: std::io::Error| {
        Error::new(format!("cannot change {shown}: {error}")).help(
            "the file was not changed; make it and its folder writable, or free space on the disk, and run the \
             command again",
        )
    };
    // Where a link leads: the file there is replaced, and not the link.
    let target = path.canonicalize().map_err(failed)?;
    let folder = target.parent().unwrap_or(Path::new("."));
    let about = target.metadata().map_err(failed)?;
    if about.permissions().readonly() {
        return Err(failed(std::io::ErrorKind::PermissionDenied.into()));
    }
    let mut beside = tempfile::Builder::new().prefix(".onshell-").tempfile_in(folder).map_err(failed)?;
    beside.write_all(after).map_err(failed)?;
    beside.as_file().set_permissions(about.permissions()).map_err(failed)?;
    keep_owner(beside.path(), &about).map_err(failed)?;
    beside.as_file().sync_all().map_err(failed)?;
    // As late as possible: what an editor wrote in between would be lost.
    if std::fs::read(&target).map_err(failed)? != before {
        return Err(Error::new(format!("{shown} has changed since it was checked"))
            .help("the file was not edited; run the command again"));
    }
    beside.persist(&target).map_err(|error| failed(error.error))?;
    Ok(())
}

/// Gives a file the owner and the group of another one.
#[cfg(unix)]
fn keep_owner(path: &Path, about: &std::fs::Metadata) -> std::io::Result<()> {
    use std::os::unix::fs::{MetadataExt, chown};
    let own = path.metadata()?;
    match (own.uid(), own.gid()) == (about.uid(), about.gid()) {
        true => Ok(()),
        false => chown(path, Some(about.uid()), Some(about.gid())),
    }
}

/// Files have no owner that a rename would change.
#[cfg(not(unix))]
fn keep_owner(_: &Path, _: &std::fs::Metadata) -> std::io::Result<()> {
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A folder with notes in it.
    fn desk() -> (tempfile::TempDir, std::path::PathBuf) {
        let desk = tempfile::tempdir().unwrap();
        let path = desk.path().join("notes.md");
        std::fs::write(&path, "before").unwrap();
        (desk, path)
    }

    fn names(folder: &Path) -> Vec<String> {
        let entries = std::fs::read_dir(folder).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    #[test]
    fn what_changed_meanwhile_is_not_overwritten() {
        let (desk, path) = desk();
        std::fs::write(&path, "edited by someone else").unwrap();
        let error = replace(&path, b"before", b"after").unwrap_err();
        assert!(error.to_string().contains("has changed since it was checked"), "{error}");
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "edited by someone else");
        assert_eq!(names(desk.path()), ["notes.md"], "nothing is left beside it");
        // The twin: what did not change is replaced.
        replace(&path, b"edited by someone else", b"after").unwrap();
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "after");
    }

    #[test]
    fn what_is_gone_is_not_made_again() {
        let (desk, path) = desk();
        std::fs::remove_file(&path).unwrap();
        assert!(replace(&path, b"before", b"after").is_err());
        assert_eq!(names(desk.path()), [""; 0]);
    }

    #[test]
    fn a_file_that_is_read_only_stays() {
        let (_desk, path) = desk();
        let mut permissions = path.metadata().unwrap().permissions();
        permissions.set_readonly(true);
        std::fs::set_permissions(&path, permissions).unwrap();
        assert!(replace(&path, b"before", b"after").is_err());
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "before");
    }

    #[cfg(unix)]
    #[test]
    fn permissions_and_links_are_kept() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let (desk, path) = desk();
        std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o640)).unwrap();
        let link = desk.path().join("link.md");
        symlink("notes.md", &link).unwrap();
        replace(&link, b"before", b"after").unwrap();
        assert!(link.is_symlink(), "the link is still one");
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "after");
        assert_eq!(path.metadata().unwrap().permissions().mode() & 0o777, 0o640);
        assert_eq!(names(desk.path()), ["link.md", "notes.md"]);
    }
}
