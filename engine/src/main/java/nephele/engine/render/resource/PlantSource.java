package nephele.engine.render.resource;

import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.SharedObjects.Identity;
import nephele.engine.scene.Scene;
import nephele.engine.scene.impostor.ImpostorAtlas;
import nephele.engine.scene.light.LightRequirements;

/**
 * What the plants on the GPU follow from; equal values make equal ones.
 *
 * @param anchor world position from which places are measured
 * @param format of the colours of their atlases
 * @param decoding of these colours
 * @param texels along a side of a view
 */
public record PlantSource(
        Identity statics,
        Identity materials,
        Identity assets,
        boolean isSkyLit,
        Vec3 anchor,
        PixelFormat format,
        ColourDecoding decoding,
        int texels) {
    /** @param impostorPixels size below which impostors are drawn */
    public static PlantSource of(
            Scene scene, Vec3 anchor, PixelFormat format, ColourDecoding decoding, double impostorPixels) {
        return new PlantSource(
                new Identity(scene.statics()),
                new Identity(scene.materials()),
                new Identity(scene.assets()),
                LightRequirements.skyShines(scene.level()),
                anchor,
                format,
                decoding,
                ImpostorAtlas.texelsFor(impostorPixels));
    }
}
