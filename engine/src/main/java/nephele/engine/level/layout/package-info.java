/**
 * Rules on how the shapes of a placed level lie to each other: what fights, hides, leaks or stands in a solid. Each is a
 * {@link nephele.engine.level.placed.LevelRule}; {@code rule.LevelRules.ALL} is the list.
 */
package nephele.engine.level.layout;
