/** Symbols of entities that have no surface of their own, as marks: lamps, start, exits, cameras, clouds, portals. */
package nephele.editor.symbol;
