package nephele.engine.level;

import java.util.List;
import java.util.Map;
import nephele.engine.math.Vec3;
import nephele.engine.model.bound.Bound;

/**
 * A level as its author wrote it, version 1. Every section is optional in the file: an absent list is empty here, an
 * absent environment is the empty one, an absent player, portal gun or observer is {@code null}. Contains no derived data.
 *
 * @param aim the task of the level in a line for the player, in each language
 * @param par what a good run needs; {@code null} for none. Like the editor's notes it is only read, never simulated
 * @param landmark what the player should see: the goal's key points at it; {@code null} for the exits
 * @param hints in the order in which they are given
 * @param editor what only the editor reads: nothing that is drawn or simulated depends on it
 */
public record Level(
        @Written(absent = "\"\"") String name,
        @Written(absent = "\"\"", text = TextKind.PROSE) String description,
        @Written(absent = "{}") Environment environment,
        @Written PlayerStart player,
        @Written(most = 1000) List<Camera> cameras,
        @Written List<Material> materials,
        @Written(most = 100_000) List<Solid> solids,
        @Written(most = 1000) List<Light> lights,
        @Written(most = 1000) List<PortalSpec> portals,
        @Written List<ModelPlacement> models,
        @Written List<Body> bodies,
        @Written PortalGun portalGun,
        @Written(most = 8) List<Exit> exits,
        @Written(most = 256) List<Emitter> emitters,
        @Written(most = 16) List<Terrain> terrains,
        @Written(most = 1000) List<Billboards> billboards,
        @Written Observer observer,
        @Written(text = TextKind.NAME) Map<Language, String> aim,
        @Written Par par,
        @Written Place landmark,
        @Written(most = 100) List<Hint> hints,
        @Written(absent = "{}") EditorNotes editor) {
    /**
     * What a good run needs: the list of levels shows it beside the player's best. With its prototype the editor begins
     * a new one.
     *
     * @param seconds from the start to an exit
     * @param portals shots that open one
     */
    public record Par(
            @Written(required = true, prototype = "60") @Range(min = 0.1, max = 86_400) double seconds,
            @Written(required = true, prototype = "2") @Range(min = 0, max = 10_000) int portals) {}

    /**
     * A sphere that stands for the player's body before a camera that does not move. Billboards face its centre instead
     * of the eye, and it has another colour while it touches the bounds of a model.
     *
     * @param camera {@code null} for the level's first
     * @param bounds the volume around a model that the sphere touches, with which the game begins
     */
    public record Observer(
            @Written(text = TextKind.ID, refersTo = "cameras") String camera,
            @Written(absent = "0.5", spatial = Spatial.LENGTH) @Range(min = 0.05, max = 100) double radiusMetres,
            @Written(absent = "\"sphere\"") Bound bounds) {}

    /** Returns the centre of the observer's sphere at the start; {@code null} without an observer or a player. */
    public Vec3 observerStart() {
        return observer == null || player == null ? null : player.feet().plus(new Vec3(0, observer.radiusMetres(), 0));
    }

    /** Returns a level with an environment and cameras and nothing else. */
    public static Level of(String name, String description, Environment environment, List<Camera> cameras) {
        return new Level(
                name,
                description,
                environment,
                null,
                cameras,
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                null,
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                null,
                Map.of(),
                null,
                null,
                List.of(),
                EditorNotes.NONE);
    }

    /** Returns this level with another start of the player and another portal gun; either can be {@code null}. */
    public Level with(PlayerStart otherStart, PortalGun otherGun) {
        return RecordCopy.with(this, "player", otherStart, "portalGun", otherGun);
    }

    /** Returns this level with other portals. */
    public Level withPortals(List<PortalSpec> otherPortals) {
        return RecordCopy.with(this, "portals", otherPortals);
    }

    /** Returns this level with another environment and other lights. */
    public Level with(Environment changed, List<Light> otherLights) {
        return RecordCopy.with(this, "environment", changed, "lights", otherLights);
    }

    /** Returns this level with other materials and solids. */
    public Level with(List<Material> otherMaterials, List<Solid> otherSolids) {
        return with(otherMaterials, otherSolids, bodies);
    }

    /** Returns this level with other materials, solids and bodies. */
    public Level with(List<Material> otherMaterials, List<Solid> otherSolids, List<Body> otherBodies) {
        return with(otherMaterials, otherSolids, otherBodies, models);
    }

    /** Returns this level with other materials, solids, bodies and models. */
    public Level with(
            List<Material> otherMaterials,
            List<Solid> otherSolids,
            List<Body> otherBodies,
            List<ModelPlacement> otherModels) {
        return RecordCopy.with(
                this, "materials", otherMaterials, "solids", otherSolids, "bodies", otherBodies, "models", otherModels);
    }

    /** Returns this level with other exits. */
    public Level withExits(List<Exit> otherExits) {
        return RecordCopy.with(this, "exits", otherExits);
    }

    /** Returns this level with other emitters. */
    public Level withEmitters(List<Emitter> otherEmitters) {
        return RecordCopy.with(this, "emitters", otherEmitters);
    }

    /** Returns this level with other terrains. */
    public Level withTerrains(List<Terrain> otherTerrains) {
        return RecordCopy.with(this, "terrains", otherTerrains);
    }

    /** Returns this level with other billboards. */
    public Level withBillboards(List<Billboards> otherBillboards) {
        return RecordCopy.with(this, "billboards", otherBillboards);
    }

    /** Returns this level with another observer; {@code null} for none. */
    public Level withObserver(Observer other) {
        return RecordCopy.with(this, "observer", other);
    }

    /** Returns this level with other notes of the editor. */
    public Level with(EditorNotes notes) {
        return RecordCopy.with(this, "editor", notes);
    }

    /** Returns what is drawn and simulated of this level: without par, landmark, hints and the editor's notes. */
    public Level withoutRemarks() {
        return RecordCopy.with(this, "par", null, "landmark", null, "hints", List.of(), "editor", EditorNotes.NONE);
    }
}
