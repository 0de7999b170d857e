package nephele.engine.level;

import java.util.List;

/**
 * A level as its author wrote it, version 1. Every section is optional in the file: an absent list is empty here, an
 * absent record {@code null}. Nothing in here is derived.
 */
public record Level(
        String name,
        String description,
        Environment environment,
        PlayerStart player,
        List<Camera> cameras,
        List<Material> materials,
        List<Solid> solids,
        List<Light> lights,
        List<PortalSpec> portals,
        List<ModelPlacement> models,
        List<Body> bodies) {}
