/**
 * Billboards and impostors of a level: their places, also those of fields, the pictures of billboards with transparency,
 * and how they are turned.
 */
package nephele.engine.level.billboard;
