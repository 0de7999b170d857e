package nephele.engine.render.frame;

import nephele.engine.cloud.drawn.CloudTimeline.Sampling;
import nephele.engine.cloud.field.LoadedClouds;
import nephele.engine.cloud.light.CloudLight;
import nephele.engine.cloud.noise.CloudTables;
import nephele.engine.render.resource.OwnedObjects;
import nephele.engine.scene.Scene;

/** The parts of clouds that outlive a level: they follow from a seed or from optics alone, and take long to derive. */
final class LastingClouds {
    private final OwnedObjects owner;

    LastingClouds(OwnedObjects owner) {
        this.owner = owner;
    }

    CloudTables tables(long seed) {
        return owner.lasting(CloudTables.class, seed, () -> CloudTables.of(seed));
    }

    /** @param loaded the level's clouds, each with the technique that draws it */
    FrameClouds drawn(Scene scene, LoadedClouds loaded, Quality quality) {
        var sampling = new Sampling(
                quality.cloudLightCell(),
                quality.proceduralNoise(),
                optics -> owner.lasting(CloudLight.class, optics, () -> new CloudLight(optics)));
        return new FrameClouds(scene, loaded, sampling);
    }
}
