/**
 * Passes and their arguments.
 *
 * <p>A pass class has a constant {@code FEATURE}: a {@link nephele.engine.render.frame.RenderFeature} that decides, for
 * a {@link nephele.engine.render.frame.FrameRequest}, whether the pass is required and why, and names the {@link
 * nephele.engine.render.frame.SharedResource}s that it uses. {@code RenderFeatures.ALL} lists the features in frame
 * order. A {@link nephele.engine.render.frame.Pass} is built once from a {@link nephele.engine.render.frame.LoadContext}
 * and drawn with a {@link nephele.engine.render.frame.FrameContext} for each view, in its {@link
 * nephele.engine.render.frame.Stage}. Shaders are beside the pass; shared ones are in {@code
 * nephele/engine/render/include}.
 */
package nephele.engine.render.frame;
