package nephele.engine.render.frame;

import java.util.List;
import nephele.engine.choice.ChosenTechniques;
import nephele.engine.choice.CloudColumns;
import nephele.engine.choice.ErrorTable;
import nephele.engine.cloud.drawn.CloudTimeline;
import nephele.engine.cloud.drawn.CloudTimeline.Sampling;
import nephele.engine.cloud.field.LoadedClouds;
import nephele.engine.cloud.light.CloudLight;
import nephele.engine.cloud.noise.CloudTables;
import nephele.engine.level.Camera;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.PortalGun;
import nephele.engine.level.PortalSpec;
import nephele.engine.render.gl.SharedObjects.Same;
import nephele.engine.render.resource.OwnedObjects;
import nephele.engine.scene.Scene;
import nephele.engine.sim.reach.EyeReach;

/**
 * Finds the technique of each cloud of a scene, and makes the clouds that are drawn; what an edit leaves as it was is not
 * computed again.
 */
final class LevelTechniques {
    private final OwnedObjects owner;
    private final Scene scene;

    /** What the clouds and their columns follow from. */
    private record Causes(Same assets, Environment environment) {}

    /** What the places of an eye follow from. */
    private record Places(
            Same statics, PlayerStart player, List<PortalSpec> portals, PortalGun gun, List<Camera> cameras) {}

    LevelTechniques(OwnedObjects owner, Scene scene) {
        this.owner = owner;
        this.scene = scene;
    }

    CloudColumns columns() {
        Environment environment = scene.level().environment();
        return owner.shareValue(
                CloudColumns.class,
                new Causes(new Same(scene.assets()), CloudTimeline.causes(environment)),
                () -> CloudColumns.of(LoadedClouds.of(environment, scene.assets(), this::tables)));
    }

    private CloudTables tables(long seed) {
        return owner.lasting(CloudTables.class, seed, () -> CloudTables.of(seed));
    }

    /** Returns clouds to draw. @param loaded those of the level, each with the technique that draws it */
    FrameClouds drawn(LoadedClouds loaded, Quality quality) {
        var sampling = new Sampling(
                quality.cloudLightCell(),
                quality.proceduralNoise(),
                optics -> owner.lasting(CloudLight.class, optics, () -> new CloudLight(optics)));
        return new FrameClouds(scene, loaded, sampling);
    }

    List<CloudTechnique> chosen(CloudColumns columns) {
        boolean isWritten =
                columns.loaded().clouds().stream().noneMatch(cloud -> cloud.technique() == CloudTechnique.AUTO);
        return ChosenTechniques.of(
                        scene.level().environment(),
                        columns,
                        isWritten ? EyeReach.ANYWHERE : reach(),
                        owner.shareValue(
                                ErrorTable.class, new Same(scene.assets()), () -> ErrorTable.of(scene.assets())))
                .techniques();
    }

    EyeReach reach() {
        Level level = scene.level();
        return owner.shareValue(
                EyeReach.class,
                new Places(
                        new Same(scene.statics()), level.player(), level.portals(), level.portalGun(), level.cameras()),
                () -> EyeReach.of(level, scene.statics()));
    }
}
