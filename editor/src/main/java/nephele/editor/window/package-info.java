/** The window shell in Swing: menus, toolbar, slots for panels, status bar, palette and dialogues. */
package nephele.editor.window;
