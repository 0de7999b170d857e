/**
 * The records of a level as data: sections, entities and components, found by their declarations alone. A record class
 * that a later version adds to the level appears in palette, outliner and inspector without a change of the editor.
 */
package nephele.editor.record;
