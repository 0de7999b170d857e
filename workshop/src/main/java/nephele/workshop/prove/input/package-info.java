/** Levels whose numbers are odd: made from the records and their ranges, and used in every way that accepts them. */
package nephele.workshop.prove.input;
