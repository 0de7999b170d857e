/** The proof that data derived from an edited level equal those of the freshly loaded level, and its town. */
package nephele.workshop.prove.edits;
