package nephele.engine.render.frame;

import java.util.Map;
import java.util.function.Supplier;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.OwnedObjects;
import nephele.engine.render.gl.SharedObjects.Identity;
import nephele.engine.render.gl.Texture;
import nephele.engine.scene.Scene;

/**
 * The arguments for building a pass or a shared resource, once per renderer.
 *
 * @param targets the textures that passes have written for later ones; each still belongs to its pass
 * @param owner closes what is built
 * @param feature the feature whose pass is built; {@code null} for a shared resource
 */
public record LoadContext(
        GlContext gl,
        DrawnScene drawn,
        FrameRequest request,
        RenderResources resources,
        Map<Target, Texture> targets,
        OwnedObjects owner,
        RenderFeature feature) {

    /** Returns the arguments for building what another owner closes. */
    public LoadContext ownedBy(OwnedObjects other) {
        return new LoadContext(gl, drawn, request, resources, targets, other, feature);
    }

    /** Returns the arguments for building what follows from another scene, such as the one before an edit. */
    public LoadContext with(DrawnScene other) {
        return new LoadContext(gl, other, request, resources, targets, owner, feature);
    }

    public Scene scene() {
        return drawn.scene();
    }

    public Output output() {
        return request.output();
    }

    public Quality quality() {
        return request.quality();
    }

    /**
     * Returns a shared object, {@code null} if the level has none.
     *
     * @throws IllegalStateException if the feature does not name it
     */
    public <T> T get(SharedResource<T> resource) {
        if (feature != null && !feature.uses().contains(resource)) {
            throw new IllegalStateException(
                    feature.name() + " does not name " + resource.name() + " among what it uses");
        }
        return resources.get(resource);
    }

    /** Returns a key for data that belong to one opened level, in all its edited versions. */
    public Identity openedLevel() {
        return new Identity(scene().assets());
    }

    /** Keeps an object until its owner is closed: a pass closes nothing itself. */
    public <T extends GlObject> T own(T object) {
        return owner.own(object);
    }

    /**
     * Returns an object that all renderers of the context share if they request it for the same value.
     *
     * @param madeFrom an immutable value from which the object follows
     */
    public <T extends GlObject> T share(Class<T> kind, Object madeFrom, Supplier<T> make) {
        return owner.share(kind, madeFrom, make);
    }

    /** Shares a value that needs no closing: derived once for as long as any renderer of the context uses it. */
    public <T> T shareValue(Class<T> kind, Object madeFrom, Supplier<T> make) {
        return owner.shareValue(kind, madeFrom, make);
    }
}
