/** The models of a level that are drawn as impostors: their kinds, and the places of single ones and of fields. */
package nephele.engine.level.planted;
