package nephele.engine.level;

import nephele.engine.math.Vec3;

/** A portal that the level starts with. */
public record PortalSpec(
        String id,
        String linkedTo,
        Vec3 centre,
        Vec3 normal,
        Vec3 up,
        double widthMetres,
        double heightMetres,
        PortalShape shape) {}
