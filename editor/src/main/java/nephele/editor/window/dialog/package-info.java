/** The dialogues: search lists, forms that ask for the values of actions, the choice of an asset, explained pixels. */
package nephele.editor.window.dialog;
