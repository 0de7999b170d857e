/**
 * What a pass is and what it is given.
 *
 * <p>A pass class carries {@code public static final RenderFeature FEATURE}, which looks at a level and says what
 * requires it; {@code nephele.engine.render.RenderFeatures.ALL} lists the features in frame order. A {@link
 * nephele.engine.render.frame.Pass} is built with the context, then {@link nephele.engine.render.frame.Pass#load}ed
 * once with a {@link nephele.engine.render.frame.LoadContext} (scene, output, quality, what passes share), then drawn
 * with a {@link nephele.engine.render.frame.FrameContext} per view. Shaders lie beside the pass; what they share lies in
 * {@code nephele/engine/render/include}: {@code frame.glsl} (the view's uniform block), {@code output.glsl} (the only
 * place that tone-maps, encodes and dithers), and the surface lighting.
 */
package nephele.engine.render.frame;
