/**
 * Draws levels: {@code LevelRenderer.load(gl, level, assets, settings)}, then {@code draw(view, target)} for each frame,
 * {@code Capture} for pictures. {@code RenderFeatures.ALL} is the frame order and the only registration; {@code
 * FramePlan.of} says what a level requires and why ({@code explain}).
 *
 * <pre>{@code
 * try (GlContext gl = GlContext.offscreen();
 *         RenderTarget picture = RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, 1280, 720);
 *         Renderer renderer = LevelRenderer.load(gl, level, assets, RenderSettings.of(Output.DIRECT))) {
 *     renderer.draw(View.ofCamera(level.cameras().get(0), 0, 1280 / 720.0), picture);
 *     Capture.png(picture, Path.of("out.png"));
 * }
 * }</pre>
 */
package nephele.engine.render;
