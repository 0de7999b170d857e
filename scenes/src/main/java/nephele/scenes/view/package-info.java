/** The state of the scene viewer: its camera, the entity towed before it and the scene's clock, without a window. */
package nephele.scenes.view;
