package nephele.engine.level;

import java.util.List;
import java.util.Map;

/**
 * A level as its author wrote it, version 1. Every section is optional in the file: an absent list is empty here, an
 * absent environment is the empty one, an absent player or portal gun is {@code null}. Contains no derived data.
 *
 * @param aim the task of the level in a line for the player, in each language
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
        @Written(text = TextKind.NAME) Map<Language, String> aim,
        @Written(absent = "{}") EditorNotes editor) {
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
                Map.of(),
                EditorNotes.NONE);
    }

    /** Returns this level with other portals. */
    public Level withPortals(List<PortalSpec> otherPortals) {
        return new Level(
                name,
                description,
                environment,
                player,
                cameras,
                materials,
                solids,
                lights,
                otherPortals,
                models,
                bodies,
                portalGun,
                exits,
                aim,
                editor);
    }

    /** Returns this level with another environment and other lights. */
    public Level with(Environment changed, List<Light> otherLights) {
        return new Level(
                name,
                description,
                changed,
                player,
                cameras,
                materials,
                solids,
                otherLights,
                portals,
                models,
                bodies,
                portalGun,
                exits,
                aim,
                editor);
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
        return new Level(
                name,
                description,
                environment,
                player,
                cameras,
                otherMaterials,
                otherSolids,
                lights,
                portals,
                otherModels,
                otherBodies,
                portalGun,
                exits,
                aim,
                editor);
    }

    /** Returns this level with other exits. */
    public Level withExits(List<Exit> otherExits) {
        return new Level(
                name,
                description,
                environment,
                player,
                cameras,
                materials,
                solids,
                lights,
                portals,
                models,
                bodies,
                portalGun,
                otherExits,
                aim,
                editor);
    }

    /** Returns this level with other notes of the editor. */
    public Level with(EditorNotes notes) {
        return new Level(
                name,
                description,
                environment,
                player,
                cameras,
                materials,
                solids,
                lights,
                portals,
                models,
                bodies,
                portalGun,
                exits,
                aim,
                notes);
    }
}
