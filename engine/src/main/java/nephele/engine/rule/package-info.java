/**
 * The checks of a level: {@link nephele.engine.rule.LevelRules#ALL} is the one list of them, and {@link
 * nephele.engine.rule.LevelRules#check} applies it. All are here but that of leaks in {@code level.layout} and those of
 * fixed portals in {@code portal.placement}.
 */
package nephele.engine.rule;
