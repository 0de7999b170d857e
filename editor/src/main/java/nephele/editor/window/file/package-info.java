/** Files in the window: the offer to recover lost work, backups, dropped files, and questions about changes on disk. */
package nephele.editor.window.file;
