/**
 * The checks of a level: {@link nephele.engine.rule.LevelRules#ALL} is the one list of them, and {@link
 * nephele.engine.rule.LevelRules#check} applies it. Here are those of records, of files and of the world in which the
 * player starts; those of shapes are in {@code level.layout}, those of fixed portals in {@code portal.placement}.
 */
package nephele.engine.rule;
