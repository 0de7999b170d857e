package nephele.engine.level;

import nephele.engine.math.Vec3;

/** A portal that exists at the start of the level. */
public record PortalSpec(
        @Written(required = true, text = TextKind.ID) String id,
        @Written(required = true, text = TextKind.ID, refersTo = "portals") String linkedTo,
        @Written(required = true, spatial = Spatial.POINT) @Range Vec3 centre,
        @Written(required = true, spatial = Spatial.DIRECTION, prototype = "[0, 0, 1]")
                @Range(min = 1e-9, shape = Range.Shape.DIRECTION)
                Vec3 normal,
        @Written(absent = "[0, 1, 0]", spatial = Spatial.DIRECTION) @Range(min = 1e-9, shape = Range.Shape.DIRECTION)
                Vec3 up,
        @Written(absent = "1.2", spatial = Spatial.LENGTH) @Range(min = 1e-2) double widthMetres,
        @Written(absent = "2.1", spatial = Spatial.LENGTH) @Range(min = 1e-2) double heightMetres,
        @Written(absent = "\"arch\"") PortalShape shape) {}
