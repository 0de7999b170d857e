/**
 * Levels as files of the editor: opened, saved with backups, watched, packed. No save fails silently: each returns a {@link
 * nephele.editor.save.SaveResult} whose message says which file, why, and what to do.
 */
package nephele.editor.save;
