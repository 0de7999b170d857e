package nephele.engine.render.frame;

import java.lang.ref.WeakReference;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.Map;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Texture;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.LightNeeds;
import nephele.engine.scene.light.SkyProbes;
import nephele.engine.scene.thing.Things;

/** What several passes of one level use; made when the first of them asks, closed with the level. */
public final class SharedResources implements AutoCloseable {
    private final GlContext gl;
    private final Scene scene;
    private final Map<Target, Texture> textures = new EnumMap<>(Target.class);
    private final Map<String, WeakReference<Picture>> decoded = new HashMap<>();
    private FrameUniforms frameUniforms;
    private SolidMesh solids;
    private PictureArrays colourPictures;
    private PictureArrays normalPictures;
    private SurfaceLight surfaceLight;
    private OpeningMesh openings;
    private ThingMeshes things;

    public SharedResources(GlContext gl, Scene scene) {
        this.gl = gl;
        this.scene = scene;
    }

    /** The block of {@code frame.glsl}, bound at {@link FrameUniforms#BINDING}. */
    public FrameUniforms frameUniforms() {
        if (frameUniforms == null) {
            frameUniforms = new FrameUniforms(gl, scene.level().environment());
        }
        return frameUniforms;
    }

    /** Where portals open in the views of this frame. */
    public OpeningMesh openings() {
        if (openings == null) {
            openings = new OpeningMesh(gl);
        }
        return openings;
    }

    /** The static geometry on the GPU. */
    public SolidMesh solids() {
        if (solids == null) {
            solids = new SolidMesh(gl, scene.solids());
        }
        return solids;
    }

    /** Base colours: decoded from sRGB when sampled, except for output PLAIN. */
    public PictureArrays colourPictures(LoadContext context) {
        if (colourPictures == null) {
            PixelFormat format = context.output() == Output.PLAIN ? PixelFormat.RGBA8 : PixelFormat.SRGB8_ALPHA8;
            int anisotropy = context.quality().anisotropy();
            colourPictures = new PictureArrays(gl, scene.materials().colourArrays(), format, anisotropy);
        }
        return colourPictures;
    }

    /** Normal maps, alpha multiplying roughness. */
    public PictureArrays normalPictures(LoadContext context) {
        if (normalPictures == null) {
            int anisotropy = context.quality().anisotropy();
            normalPictures = new PictureArrays(gl, scene.materials().normalArrays(), PixelFormat.RGBA8, anisotropy);
        }
        return normalPictures;
    }

    /** What moves, on the GPU. */
    public ThingMeshes things(LoadContext context) {
        if (things == null) {
            Things all = Things.of(
                    scene.level(), scene.materials(), context.request().figure());
            things = new ThingMeshes(gl, all, surfaceLight(context).anchor(), skyProbes());
        }
        return things;
    }

    private SkyProbes skyProbes() {
        boolean wanted = LightNeeds.skyShines(scene.level());
        return wanted ? new SkyProbes(scene.statics()) : null;
    }

    /** Defines, uniforms and textures of {@code surface-light.glsl}. */
    public SurfaceLight surfaceLight(LoadContext context) {
        if (surfaceLight == null) {
            surfaceLight = new SurfaceLight(gl, scene, context, this::picture);
        }
        return surfaceLight;
    }

    /**
     * A decoded asset. Two passes that load one after the other share it; nothing keeps it from being freed after that.
     *
     * @throws nephele.engine.asset.AssetException naming the picture that cannot be used
     */
    public Picture picture(String assetId) {
        WeakReference<Picture> known = decoded.get(assetId);
        Picture picture = known == null ? null : known.get();
        if (picture == null) {
            picture = PictureDecoder.decode(assetId, scene.assets().bytes(assetId));
            decoded.put(assetId, new WeakReference<>(picture));
        }
        return picture;
    }

    /** Makes a target's texture known to the passes after this one; it stays the publisher's. */
    public void publish(Target target, Texture texture) {
        textures.put(target, texture);
    }

    /** What an earlier pass has published. */
    public Texture texture(Target target) {
        Texture texture = textures.get(target);
        if (texture == null) {
            throw new IllegalStateException(target + " is read, but no pass has published it");
        }
        return texture;
    }

    @Override
    public void close() {
        if (frameUniforms != null) {
            frameUniforms.close();
        }
        if (solids != null) {
            solids.close();
        }
        if (colourPictures != null) {
            colourPictures.close();
        }
        if (normalPictures != null) {
            normalPictures.close();
        }
        if (surfaceLight != null) {
            surfaceLight.close();
        }
        if (openings != null) {
            openings.close();
        }
        if (things != null) {
            things.close();
        }
    }
}
