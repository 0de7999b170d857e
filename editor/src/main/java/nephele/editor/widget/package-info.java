/** Swing parts and drawn symbols that panels, dialogues and settings pages share. */
package nephele.editor.widget;
