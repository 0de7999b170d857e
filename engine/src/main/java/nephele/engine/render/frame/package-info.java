/**
 * What a pass is and what it is given.
 *
 * <p>A pass class carries {@code public static final RenderFeature FEATURE}, which looks at a {@link
 * nephele.engine.render.frame.FrameRequest} and says what in it requires the pass; {@code nephele.engine.render.RenderFeatures.ALL} lists the features in frame order. A {@link
 * nephele.engine.render.frame.Pass} is built with the context, then {@link nephele.engine.render.frame.Pass#load}ed
 * once with a {@link nephele.engine.render.frame.LoadContext} (scene, output, quality, what passes share), then drawn
 * with a {@link nephele.engine.render.frame.FrameContext} per view, in its {@link nephele.engine.render.frame.Stage}. Shaders lie beside the pass; what they share lies in
 * {@code nephele/engine/render/include}: {@code frame.glsl} (the view's uniform block), {@code output.glsl} (the only
 * place that tone-maps, encodes and dithers), and the surface lighting.
 */
package nephele.engine.render.frame;
