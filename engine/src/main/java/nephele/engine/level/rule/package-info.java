/**
 * The checks of a level that need nothing but its records. Each {@link nephele.engine.level.rule.LevelRule} covers one
 * topic; {@link nephele.engine.level.rule.LevelRules#STRUCTURE} is the list, {@link
 * nephele.engine.level.rule.LevelRules#ALL} has two more that read pictures and meshes.
 */
package nephele.engine.level.rule;
