/** The painters' tools: colours, ramps, noise that tiles, surfaces with height, letters and shapes. */
package nephele.workshop.art.paint;
