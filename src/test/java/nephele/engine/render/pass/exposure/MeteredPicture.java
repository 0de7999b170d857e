package nephele.engine.render.pass.exposure;

import java.nio.ByteBuffer;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.TestLevel;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.RenderResources;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.OwnedObjects;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.resource.MeteredExposure;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Scene;
import nephele.engine.scene.dynamic.CharacterPresence;
import org.lwjgl.BufferUtils;

/** Meters any picture with the pass alone. */
final class MeteredPicture implements AutoCloseable {
    private final RenderResources resources;
    private final Pass pass;
    private final FrameState state;
    private final RenderTarget picture;

    MeteredPicture(GlContext gl, int width, int height) {
        Level level = new TestLevel().autoExposure().level();
        Scene scene = Scene.of(level, TestAssets.NONE);
        FrameRequest request =
                FrameRequest.of(level, scene.statics(), null, Output.HDR, Quality.HIGH, CharacterPresence.NEVER);
        OwnedObjects owned = new OwnedObjects(gl);
        resources = new RenderResources(owned, LevelRenderer.drawn(owned, scene), request, null);
        pass = ExposurePass.FEATURE
                .requiredBy()
                .apply(request)
                .get(0)
                .build()
                .apply(resources.context(ExposurePass.FEATURE));
        state = FrameState.atStart(level);
        picture = RenderTarget.picture(gl, "metered", PixelFormat.RGBA16F, width, height);
    }

    /** Shows the picture at a time, and returns the exposure that it is shown with, in stops. */
    double stops(float[] rgb, double seconds) {
        float[] shares = new float[rgb.length / 3];
        java.util.Arrays.fill(shares, 1);
        return stops(rgb, shares, seconds);
    }

    /** @param shares the share of each pixel that is metered */
    double stops(float[] rgb, float[] shares, double seconds) {
        ByteBuffer texels = BufferUtils.createByteBuffer(16 * shares.length);
        for (int i = 0; i < shares.length; i++) {
            texels.putFloat(rgb[3 * i])
                    .putFloat(rgb[3 * i + 1])
                    .putFloat(rgb[3 * i + 2])
                    .putFloat(shares[i]);
        }
        picture.colour().upload(0, texels.flip());
        state.seconds(seconds);
        exposure().begin(state, picture);
        FrameContext frame = new FrameContext(null);
        frame.begin(state, picture);
        frame.setPictures(picture, null);
        pass.draw(frame);
        return exposure().readStops();
    }

    MeteredExposure exposure() {
        return resources.get(MeteredExposure.RESOURCE);
    }

    @Override
    public void close() {
        picture.close();
        resources.close();
    }
}
