package nephele.engine.choice;

import java.util.Arrays;
import java.util.List;
import java.util.function.BiFunction;
import nephele.engine.asset.AssetSource;
import nephele.engine.cloud.drawn.CloudTimeline;
import nephele.engine.cloud.field.LoadedClouds;
import nephele.engine.cloud.noise.CloudTables;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.math.Vec3;
import nephele.engine.model.BoundingSphere;
import nephele.engine.render.RenderFeatures;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.DrawnScene;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.OwnedObjects;
import nephele.engine.render.gl.SharedObjects.Identity;
import nephele.engine.scene.Scene;
import nephele.engine.sim.reach.EyeReach;

/**
 * Builds renderers of levels: decides what follows from where an eye can be, which drawing itself does not know. Renderers
 * of one context share these decisions, and an edit that leaves their causes as they were repeats none.
 */
public final class LevelRenderer {
    private LevelRenderer() {}

    /**
     * Builds what a level requires.
     *
     * @throws nephele.engine.asset.AssetException that names a picture that cannot be used
     */
    public static Renderer load(GlContext gl, Level level, AssetSource assets, RenderSettings settings) {
        return load(gl, Scene.of(level, assets), settings);
    }

    /**
     * Builds a renderer as {@link #load(GlContext, Level, AssetSource, RenderSettings)} does, from a derived scene.
     * Renderers of one context and scene share geometry, pictures and shadow maps on the GPU.
     */
    public static Renderer load(GlContext gl, Scene scene, RenderSettings settings) {
        return load(gl, scene, settings, RenderFeatures.ALL);
    }

    /** Builds a renderer with a list of features other than the registered ones. */
    public static Renderer load(GlContext gl, Scene scene, RenderSettings settings, List<RenderFeature> features) {
        return build(gl, scene, (owned, drawn) -> Renderer.load(owned, drawn, settings, features));
    }

    /**
     * Returns a renderer of the edited level and closes the one before. Unchanged data stay on the GPU; shadow maps that
     * changed are drawn again with the next frame.
     *
     * @param edited derived from the renderer's scene
     * @throws nephele.engine.asset.AssetException that names a picture that cannot be used; the renderer then stays open
     */
    public static Renderer edited(Renderer renderer, Scene edited) {
        return build(renderer.gl(), edited, renderer::edited);
    }

    /**
     * Returns a renderer of the edited level as {@link #edited} does, in which clouds that the edit leaves as they are
     * change from the techniques of the one before to their new ones in the time that {@link Renderer#elapse} receives.
     */
    public static Renderer editedGradually(Renderer renderer, Scene edited) {
        return build(renderer.gl(), edited, renderer::editedGradually);
    }

    private static Renderer build(GlContext gl, Scene scene, BiFunction<OwnedObjects, DrawnScene, Renderer> build) {
        OwnedObjects owned = new OwnedObjects(gl);
        try {
            return build.apply(owned, drawn(owned, scene));
        } catch (RuntimeException e) {
            owned.close();
            throw e;
        }
    }

    /** Decides how a scene is drawn. @param owned keeps what renderers of the context share */
    public static DrawnScene drawn(OwnedObjects owned, Scene scene) {
        CloudColumns columns = columns(owned, scene);
        List<CloudTechnique> techniques = techniques(owned, scene, columns);
        EyeReach eyes = techniques.contains(CloudTechnique.SKYBOX) ? reach(owned, scene) : EyeReach.ANYWHERE;
        return new DrawnScene(scene, columns.loaded(), techniques, eyes.isAnywhere() ? null : sphere(eyes));
    }

    private static CloudColumns columns(OwnedObjects owned, Scene scene) {
        Environment environment = scene.level().environment();
        return owned.shareValue(
                CloudColumns.class,
                List.of(new Identity(scene.assets()), CloudTimeline.causes(environment)),
                () -> CloudColumns.of(LoadedClouds.of(environment, scene.assets(), seed -> tables(owned, seed))));
    }

    private static CloudTables tables(OwnedObjects owned, long seed) {
        return owned.lasting(CloudTables.class, seed, () -> CloudTables.of(seed));
    }

    private static List<CloudTechnique> techniques(OwnedObjects owned, Scene scene, CloudColumns columns) {
        List<CloudTechnique> written = columns.loaded().clouds().stream()
                .map(cloud -> cloud.technique())
                .toList();
        if (!written.contains(CloudTechnique.AUTO)) {
            return written;
        }
        ErrorTable table =
                owned.shareValue(ErrorTable.class, new Identity(scene.assets()), () -> ErrorTable.of(scene.assets()));
        return ChosenTechniques.of(scene.level().environment(), columns, reach(owned, scene), table)
                .techniques();
    }

    private static EyeReach reach(OwnedObjects owned, Scene scene) {
        Level level = scene.level();
        return owned.shareValue(
                EyeReach.class,
                Arrays.asList(
                        new Identity(scene.statics()),
                        level.player(),
                        level.portals(),
                        level.portalGun(),
                        level.cameras()),
                () -> EyeReach.of(level, scene.statics()));
    }

    private static BoundingSphere sphere(EyeReach eyes) {
        Vec3 middle = eyes.bounds().centre();
        return new BoundingSphere(middle, eyes.farthestMetres(middle));
    }
}
