/**
 * The action table: everything that a user can do by name, and the commands, keys and key names made from it. Menus,
 * toolbar, keys, command palette, scripts and docs/editor-keys.md follow from {@link nephele.editor.action.Actions#ALL}.
 */
package nephele.editor.action;
