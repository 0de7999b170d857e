/**
 * Rules on how the shapes of a placed level lie to each other: what fights, hides, leaks or stands in a solid. {@link
 * nephele.engine.level.layout.LayoutRules#ALL} is the list.
 */
package nephele.engine.level.layout;
