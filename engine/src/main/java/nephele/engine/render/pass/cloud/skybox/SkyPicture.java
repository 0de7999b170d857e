package nephele.engine.render.pass.cloud.skybox;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;

/**
 * The pictures of a cloud at one time, seen from one point. Two layers for each: premultiplied radiance before the air and
 * coverage, then the kilometres to the cloud times coverage.
 */
final class SkyPicture implements GlObject {
    private static final int LAYERS_OF_FACE = 2;

    private final GlContext gl;
    private final List<RenderTarget> targets = new ArrayList<>();
    /** {@code null} before the first use. */
    private Texture texture;

    private BakedFaces faces;
    private Moment moment;

    /**
     * What the pictures show.
     *
     * @param drift how far the wind has carried the cloud
     * @param nearestMetres distance to the cloud
     * @param middleMetres distance to its middle, which of a layer is that upwards
     * @param isLayer whether the cloud is endless
     * @param presence fraction of its extinction
     * @param towardsSun unit
     */
    record Moment(
            double seconds,
            Vec3 drift,
            double nearestMetres,
            double middleMetres,
            boolean isLayer,
            double presence,
            Vec3 towardsSun) {}

    SkyPicture(GlContext gl) {
        this.gl = gl;
    }

    /** Becomes the pictures of another time, not drawn yet. */
    void begin(BakedFaces newFaces, Moment newMoment) {
        faces = newFaces;
        moment = newMoment;
        boolean fits = texture != null
                && targets.size() == faces.count()
                && texture.extent().width() == faces.width()
                && texture.extent().height() == faces.height();
        if (!fits) {
            close();
            allocate();
        }
    }

    private void allocate() {
        int layers = LAYERS_OF_FACE * faces.count();
        texture = new Texture(
                gl,
                "skybox of a cloud",
                Texture.Shape.ARRAY,
                PixelFormat.RGBA16F,
                new Texture.Extent(faces.width(), faces.height(), layers),
                Sampling.LINEAR_CLAMP);
        for (int layer = 0; layer < layers; layer += LAYERS_OF_FACE) {
            targets.add(RenderTarget.colourLayers(gl, "face of a cloud", texture, layer, LAYERS_OF_FACE));
        }
    }

    BakedFaces faces() {
        return faces;
    }

    Moment moment() {
        return moment;
    }

    /** Returns the distance at which the cloud is taken to be where the wind moves it; 0 if that depends on the direction. */
    double distanceOfShift() {
        return moment.isLayer ? 0 : moment.middleMetres;
    }

    RenderTarget target(int layer) {
        return targets.get(layer);
    }

    void bind(TextureUnit unit) {
        texture.bind(unit);
    }

    @Override
    public void close() {
        if (texture != null) {
            targets.forEach(RenderTarget::close);
            targets.clear();
            texture.close();
            texture = null;
        }
    }
}
