/**
 * What is decided about a level before it is drawn. {@link nephele.engine.choice.LevelRenderer} builds its renderer. Which
 * technique draws a cloud whose technique is auto: {@link nephele.engine.choice.TechniqueChoice} takes the cheapest one
 * whose measured error is allowed where the eye can be. Errors and costs are data, {@link
 * nephele.engine.choice.ErrorTable}, which {@code trade clouds} makes.
 */
package nephele.engine.choice;
