/**
 * The action table: everything that a user can do by name. Menus, toolbar, keys, command palette, scripts and
 * docs/editor-keys.md are made from {@link nephele.editor.action.Actions#ALL} alone.
 */
package nephele.editor.action;
