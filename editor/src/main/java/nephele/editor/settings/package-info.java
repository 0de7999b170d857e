/**
 * The choices of the user of the editor. {@link nephele.editor.settings.EditorSetting} lists the settings, {@link
 * nephele.editor.settings.EditorSettings} holds their values, {@link nephele.editor.settings.EditorFiles} keeps them;
 * unknown and broken entries stay in the file.
 */
package nephele.editor.settings;
