package nephele.engine.render.frame;

import java.lang.ref.WeakReference;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.choice.TechniqueFade;
import nephele.engine.cloud.drawn.CloudTimeline;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.appearance.ShaftLight;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.SharedObjects.Same;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.resource.BackgroundWork;
import nephele.engine.render.resource.DynamicMeshes;
import nephele.engine.render.resource.FrameLightning;
import nephele.engine.render.resource.FrameUniforms;
import nephele.engine.render.resource.OpeningMesh;
import nephele.engine.render.resource.OwnedObjects;
import nephele.engine.render.resource.ShaftTables;
import nephele.engine.render.resource.SolidMesh;
import nephele.engine.render.resource.TerrainMesh;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Scene;
import nephele.engine.scene.SceneMaterials.PictureArray;
import nephele.engine.scene.View;
import nephele.engine.scene.dynamic.DynamicObjects;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.SkyProbes;
import nephele.engine.sim.reach.EyeReach;

/**
 * Resources that the passes of one renderer share, created on first use. Owned objects are closed with the renderer,
 * the last first; shared ones stay while another renderer of the context uses them.
 */
public final class SharedResources implements GlObject {
    private final GlContext gl;
    private final Scene scene;
    private final FrameRequest request;
    private final FrameEnvironment surroundings;
    private final OwnedObjects owned;
    private final Map<Target, Texture> textures = new EnumMap<>(Target.class);
    private final Map<String, WeakReference<Picture>> decoded = new HashMap<>();
    private FrameUniforms frameUniforms;
    private MeteredExposure exposure;
    /** {@code null} without air to see through. */
    private final AerialPerspective air;

    /** {@code null} if no cloud shades the air. */
    private final ShaftTables shafts;

    private SolidMesh solids;
    private List<TerrainMesh> terrains;
    private PictureArrays colourPictures;
    private PictureArrays normalPictures;
    private SurfaceLight surfaceLight;
    private OpeningMesh openings;
    private DynamicMeshes dynamicObjects;
    private SkyProbes skyProbes;
    private BackgroundWork background;
    private FrameClouds clouds;
    /** The techniques of the replaced renderer; {@code null} for clouds that begin complete. */
    private final TechniqueFade fadeBefore;

    /** The scenes for which techniques that draw clouds were chosen: what an eye reaches in them. */
    private final Map<List<CloudTechnique>, Scene> chosenFor = new HashMap<>();

    /** {@code null} until the clouds are needed. */
    private TechniqueFade fade;

    private FrameLightning lightning;
    private int cuts;

    public SharedResources(GlContext gl, Scene scene, FrameRequest request) {
        this(gl, scene, request, null);
    }

    /**
     * @param replaced those of a renderer whose techniques go over to other ones where the clouds are the same; {@code null}
     *     for a level that begins complete
     */
    public SharedResources(GlContext gl, Scene scene, FrameRequest request, SharedResources replaced) {
        this.gl = gl;
        owned = new OwnedObjects(gl);
        fadeBefore = replaced != null && hasSameClouds(scene, replaced.scene) ? replaced.fade : null;
        if (fadeBefore != null) {
            chosenFor.putAll(replaced.chosenFor);
        }
        this.scene = scene;
        this.request = request;
        surroundings = new FrameEnvironment(request.output());
        Environment environment = scene.level().environment();
        shafts = ShaftLight.isIn(environment) ? own(new ShaftTables(gl)) : null;
        air = AerialPerspective.isIn(environment) ? own(new AerialPerspective(gl, this, shafts != null)) : null;
    }

    private static boolean hasSameClouds(Scene scene, Scene other) {
        Environment causes = CloudTimeline.causes(scene.level().environment());
        return causes.equals(CloudTimeline.causes(other.level().environment()));
    }

    /** Returns the arguments for building a pass. */
    public LoadContext loadContext() {
        return new LoadContext(gl, scene, request, this, owned);
    }

    /** Keeps an object until the renderer is closed. */
    public <T extends GlObject> T own(T object) {
        return owned.own(object);
    }

    /**
     * Returns an object that all renderers of the context share if they request it for the same value.
     *
     * @param madeFrom an immutable value from which the object follows
     */
    public <T extends GlObject> T share(Class<T> kind, Object madeFrom, Supplier<T> make) {
        return owned.share(kind, madeFrom, make);
    }

    /** Shares a value that needs no closing: derived once for as long as any renderer of the context uses it. */
    public <T> T shareValue(Class<T> kind, Object madeFrom, Supplier<T> make) {
        return owned.shareValue(kind, madeFrom, make);
    }

    /** Returns the threads that compute beside the frames of this renderer. */
    public BackgroundWork background() {
        if (background == null) {
            background = own(new BackgroundWork());
        }
        return background;
    }

    /** Returns a key for data that belong to one opened level, in all its edited versions. */
    public Same openedLevel() {
        return new Same(scene.assets());
    }

    /** Notes that the next frame has nothing to do with those before it. */
    public void cut() {
        cuts++;
    }

    /** Returns the number of cuts so far: history that was made before the last one is void. */
    public int cuts() {
        return cuts;
    }

    /** Begins a frame: derives the environment's values again if the environment has changed. */
    public void follow(FrameState frameState, View view) {
        surroundings.follow(frameState.environment());
        if (clouds != null) {
            clouds.follow(frameState, view.eye());
        }
        if (lightning != null) {
            lightning.follow(frameState);
        }
        if (surfaceLight != null) {
            surfaceLight.follow(frameState.environment());
        }
        if (air != null) {
            air.follow(frameState.environment());
        }
        if (shafts != null) {
            shafts.begin();
        }
    }

    /** Sets the view of the following draws. */
    public void setView(View view) {
        if (air != null) {
            air.setView(view, frameUniforms());
        }
        if (shafts != null) {
            shafts.setView(view);
        }
        frameUniforms().upload(view, surroundings.exposure());
    }

    public FrameEnvironment surroundings() {
        return surroundings;
    }

    /**
     * Returns the block of {@code frame.glsl}.
     */
    public FrameUniforms frameUniforms() {
        if (frameUniforms == null) {
            frameUniforms = own(new FrameUniforms(gl, scene.level().environment()));
        }
        return frameUniforms;
    }

    /** Returns the exposure that is metered from the pictures; {@code null} if none is. */
    public MeteredExposure exposure() {
        if (exposure == null && MeteredExposure.isRequiredBy(request)) {
            exposure = own(new MeteredExposure(gl));
        }
        return exposure;
    }

    /** Returns the openings in the views of this frame. */
    public OpeningMesh openings() {
        if (openings == null) {
            openings = own(new OpeningMesh(gl));
        }
        return openings;
    }

    /** Returns the static geometry on the GPU. */
    public SolidMesh solids() {
        if (solids == null) {
            solids = share(SolidMesh.class, new Same(scene.solids()), () -> new SolidMesh(gl, scene.solids()));
        }
        return solids;
    }

    /** Returns the level's terrains on the GPU, in its order. */
    public List<TerrainMesh> terrains() {
        if (terrains == null) {
            terrains = scene.statics().ground().stream()
                    .map(grid ->
                            share(TerrainMesh.class, new Same(grid.field()), () -> new TerrainMesh(gl, grid.field())))
                    .toList();
        }
        return terrains;
    }

    /** Returns the level's static shapes. */
    public StaticShapes statics() {
        return scene.statics();
    }

    /** Returns the level's clouds; all techniques draw these. */
    public FrameClouds clouds() {
        if (clouds == null) {
            var found = new LevelTechniques(owned, scene);
            List<CloudTechnique> techniques = found.chosen(found.columns());
            fade = (fadeBefore == null ? TechniqueFade.complete(techniques) : fadeBefore).towards(techniques);
            chosenFor.put(techniques, scene);
            chosenFor
                    .keySet()
                    .retainAll(fade.stages().stream()
                            .map(TechniqueFade.Stage::techniques)
                            .toList());
            clouds = clouds(techniques, owned);
        }
        return clouds;
    }

    /** Returns the level's clouds as sampled for these techniques. */
    public FrameClouds clouds(List<CloudTechnique> techniques, OwnedObjects owner) {
        var found = new LevelTechniques(owned, scene);
        return owner.share(
                FrameClouds.class,
                FrameClouds.Source.of(scene, request.quality(), techniques),
                () -> found.drawn(found.columns().loaded().drawnBy(techniques), request.quality()));
    }

    /** Returns the techniques that draw the clouds, several while they change. */
    public TechniqueFade techniques() {
        clouds();
        return fade;
    }

    /** Returns the scene for which techniques were chosen, this one or one before an edit. */
    public Scene chosenFor(List<CloudTechnique> techniques) {
        return chosenFor.get(techniques);
    }

    /** Returns how far the techniques that draw the clouds have changed, 1 without a change. */
    public double changed() {
        return fade == null || fade.isComplete() ? 1 : fade.share(fade.target());
    }

    /** Lets the time of the display pass, in which techniques change. */
    public void elapse(double seconds) {
        if (fade != null && !fade.isComplete()) {
            fade = fade.after(seconds);
        }
    }

    /** Returns the level's lightning; {@code null} if there is none. */
    public FrameLightning lightning() {
        Environment environment = scene.level().environment();
        if (lightning == null && environment.hasLightning()) {
            lightning = own(new FrameLightning(gl, environment.lightning()));
        }
        return lightning;
    }

    /** Returns where the eyes of a scene, this one or one before an edit, can be. */
    public EyeReach eyeReach(Scene of) {
        return new LevelTechniques(owned, of).reach();
    }

    /** Returns the shadows of clouds in the air of the frame's views; {@code null} without. */
    public ShaftTables shafts() {
        return shafts;
    }

    /** Returns base colours, decoded from sRGB when sampled, except for output PLAIN. */
    public PictureArrays colourPictures() {
        if (colourPictures == null) {
            colourPictures =
                    pictures(scene.materials().colourArrays(), request.output().pictures());
        }
        return colourPictures;
    }

    /** Returns base colours of several sizes as one array of the greatest size. */
    public Texture colourPictures(List<Picture> pictures) {
        return PictureArrays.enlarged(gl, this, pictures, request.output().pictures(), anisotropy());
    }

    /** Returns normal maps of several sizes as one array of the greatest size. */
    public Texture normalPictures(List<Picture> pictures) {
        return PictureArrays.enlarged(gl, this, pictures, PixelFormat.RGBA8, anisotropy());
    }

    /** Returns normal maps; alpha multiplies roughness. */
    public PictureArrays normalPictures() {
        if (normalPictures == null) {
            normalPictures = pictures(scene.materials().normalArrays(), PixelFormat.RGBA8);
        }
        return normalPictures;
    }

    private PictureArrays pictures(List<PictureArray> arrays, PixelFormat format) {
        return PictureArrays.of(gl, this, arrays, format, anisotropy());
    }

    /** Mesa's llvmpipe 22.3 takes minutes for some pixels that have both several samples and anisotropic textures. */
    private int anisotropy() {
        boolean isTooSlow = gl.limits().software() && request.quality().samples() > 1;
        return isTooSlow ? 1 : request.quality().anisotropy();
    }

    /** Returns the dynamic objects on the GPU. */
    public DynamicMeshes dynamicObjects() {
        if (dynamicObjects == null) {
            DynamicObjects all = DynamicObjects.of(scene.level(), scene.materials(), request.character());
            dynamicObjects = own(new DynamicMeshes(gl, all, surfaceLight().anchor(), skyProbes()));
        }
        return dynamicObjects;
    }

    /** Returns the sky visibility of what has no place in the light map; {@code null} if no sky shines. */
    public SkyProbes skyProbes() {
        if (skyProbes == null && LightRequirements.skyShines(scene.level())) {
            skyProbes = new SkyProbes(scene.statics());
        }
        return skyProbes;
    }

    /** Returns defines, numbers and textures of {@code surface-light.glsl}. */
    public SurfaceLight surfaceLight() {
        if (surfaceLight == null) {
            surfaceLight = own(new SurfaceLight(gl, scene, request, this));
            surfaceLight.follow(scene.level().environment());
        }
        return surfaceLight;
    }

    /**
     * Returns a decoded asset. Passes that are built one after another share it; it can be garbage-collected
     * afterwards.
     *
     * @throws nephele.engine.asset.AssetException that names a picture that cannot be used
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

    /** Publishes a target's texture to the later passes; the publisher still owns it. */
    public void publish(Target target, Texture texture) {
        textures.put(target, texture);
    }

    /** Returns the texture that an earlier pass has published. */
    public Texture texture(Target target) {
        Texture texture = textures.get(target);
        if (texture == null) {
            throw new IllegalStateException(target + " is read, but no pass has published it");
        }
        return texture;
    }

    @Override
    public void close() {
        owned.close();
    }
}
