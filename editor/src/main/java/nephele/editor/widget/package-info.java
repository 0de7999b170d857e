/** Swing parts that panels, dialogues and settings pages share. */
package nephele.editor.widget;
