/**
 * Draws levels: {@code LevelRenderer.load(gl, level, assets, settings)}, then {@code draw(view, target)} for each frame,
 * {@code Capture} for pictures. {@code RenderFeatures.ALL} is the frame order and the only registration; {@code
 * FramePlan.of} says what a level requires and why ({@code explain}).
 *
 * <p>Twenty classes tell how a frame comes about. In this order: {@code Renderer}, {@code RenderSettings}, {@code
 * RenderFeatures}, {@code FramePlan}, {@code FramePasses}; what passes are made of, in {@code render.frame}: {@code Pass},
 * {@code Stage}, {@code RenderFeature}, {@code FrameRequest}, {@code LoadContext}, {@code SharedResource}, {@code
 * RenderResources}, {@code FrameContext}, {@code FrameUniforms}; views and pictures: {@code PortalViews}, {@code
 * PortalPictures}, {@code PreviousPicture}, {@code ViewCopies}, {@code Multisampling}, {@code PictureChain}.
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
