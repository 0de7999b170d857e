/** The dialogues: search lists, forms that ask for the values of actions, and the choice of an asset. */
package nephele.editor.window.dialog;
