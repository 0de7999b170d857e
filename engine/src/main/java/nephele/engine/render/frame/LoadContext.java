package nephele.engine.render.frame;

import java.util.function.Supplier;
import nephele.engine.level.billboard.PlantedBillboards;
import nephele.engine.render.frame.Quality.SpriteCoverage;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.resource.BillboardQuads;
import nephele.engine.render.resource.BillboardSource;
import nephele.engine.render.resource.OwnedObjects;
import nephele.engine.render.resource.PlantSource;
import nephele.engine.render.resource.PlantedScene;
import nephele.engine.scene.Scene;

/**
 * The arguments for building a pass, once per renderer.
 *
 * @param owner closes what is built
 */
public record LoadContext(GlContext gl, Scene scene, FrameRequest request, SharedResources shared, OwnedObjects owner) {
    /** Returns the arguments for building what another owner closes. */
    public LoadContext ownedBy(OwnedObjects other) {
        return new LoadContext(gl, scene, request, shared, other);
    }

    /** Returns the arguments for building what follows from another scene, such as the one before an edit. */
    public LoadContext with(Scene other) {
        return new LoadContext(gl, other, request, shared, owner);
    }

    public Output output() {
        return request.output();
    }

    public Quality quality() {
        return request.quality();
    }

    /** Owns an object as {@link SharedResources#own} does: a pass closes nothing itself. */
    public <T extends GlObject> T own(T object) {
        return owner.own(object);
    }

    /** Shares the level's billboards of a kind. */
    public BillboardQuads billboards(BillboardSource.Kind kind) {
        BillboardSource source = BillboardSource.of(
                scene.level(),
                scene.statics(),
                scene.assets(),
                kind,
                shared.surfaceLight().anchor(),
                output().pictures(),
                quality().spriteCoverage() == SpriteCoverage.KEPT);
        return share(
                BillboardQuads.class,
                source,
                () -> new BillboardQuads(
                        gl,
                        PlantedBillboards.of(scene.level(), scene.statics(), scene.assets()),
                        scene.statics(),
                        scene.assets(),
                        source));
    }

    /** Shares the level's models that are drawn as impostors. */
    public PlantedScene plants() {
        PlantSource source = PlantSource.of(
                scene,
                shared.surfaceLight().anchor(),
                output().pictures(),
                output().decoding(),
                quality().impostorPixels());
        return share(PlantedScene.class, source, () -> new PlantedScene(gl, scene, source));
    }

    /** Shares an object as {@link SharedResources#share} does. */
    public <T extends GlObject> T share(Class<T> kind, Object madeFrom, Supplier<T> make) {
        return owner.share(kind, madeFrom, make);
    }
}
