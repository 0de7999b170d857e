/** Billboards of a level: their places, also those of fields, their pictures with transparency, and how they are turned. */
package nephele.engine.level.billboard;
