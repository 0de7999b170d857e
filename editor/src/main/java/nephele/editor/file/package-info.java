/**
 * The life of a session's files without a window: opening and unpacking, adding files that are dropped, following
 * changes on disk, backups, and the journal with what it recovers after a crash.
 */
package nephele.editor.file;
