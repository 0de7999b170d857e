/**
 * The checks of a level that need nothing but its records. Each {@link nephele.engine.level.rule.LevelRule} covers one
 * topic; {@link nephele.engine.level.rule.LevelRules#ALL} is the list.
 */
package nephele.engine.level.rule;
