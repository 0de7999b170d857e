package nephele.engine.model.bound;

import nephele.engine.math.Vec3;

/** A bounding volume by which models are tested for contact, from the simplest to the surface itself. */
public enum Bound {
    SPHERE {
        @Override
        public boolean touches(BoundedModel model, Pose at, Vec3 centre, double radius) {
            return model.middle(at).minus(centre).length() <= model.sphere().radius() + radius;
        }

        @Override
        public boolean touch(BoundedModel a, Pose atA, BoundedModel b, Pose atB) {
            double distance = a.middle(atA).minus(b.middle(atB)).length();
            return distance <= (a.sphere().radius() + b.sphere().radius()) * (1 + SLACK);
        }
    },
    /** The box along the world's axes around the turned box of the model. */
    AXIS_ALIGNED_BOX {
        @Override
        public boolean touches(BoundedModel model, Pose at, Vec3 centre, double radius) {
            return box(model, at).upright().nearest(centre) <= radius;
        }

        @Override
        public boolean touch(BoundedModel a, Pose atA, BoundedModel b, Pose atB) {
            return box(a, atA).upright().overlaps(box(b, atB).upright());
        }
    },
    ORIENTED_BOX {
        @Override
        public boolean touches(BoundedModel model, Pose at, Vec3 centre, double radius) {
            return model.tree().box().nearest(at.seen(centre)) <= radius;
        }

        @Override
        public boolean touch(BoundedModel a, Pose atA, BoundedModel b, Pose atB) {
            return box(a, atA).touches(box(b, atB));
        }
    },
    /** Oriented boxes in a tree, down to that of each triangle. */
    HIERARCHY {
        @Override
        public boolean touches(BoundedModel model, Pose at, Vec3 centre, double radius) {
            return model.tree().touches(at.seen(centre), radius, triangle -> true);
        }

        @Override
        public boolean touch(BoundedModel a, Pose atA, BoundedModel b, Pose atB) {
            return a.tree().touches(b.tree(), atB.seenFrom(atA), (own, other) -> true);
        }
    },
    /** The triangles themselves, found through the hierarchy. */
    TRIANGLES {
        @Override
        public boolean touches(BoundedModel model, Pose at, Vec3 centre, double radius) {
            Vec3 here = at.seen(centre);
            return model.tree().touches(here, radius, triangle -> TriangleDistance.of(triangle, here) <= radius);
        }

        @Override
        public boolean touch(BoundedModel a, Pose atA, BoundedModel b, Pose atB) {
            return a.tree().touches(b.tree(), atB.seenFrom(atA), TrianglePair::touch);
        }
    };

    private static final double SLACK = 1e-9;

    /** Returns whether the volumes of two models have a point in common. */
    public abstract boolean touch(BoundedModel a, Pose atA, BoundedModel b, Pose atB);

    /** Returns whether the volume of a model has a point in common with a ball; a radius in metres. */
    public abstract boolean touches(BoundedModel model, Pose at, Vec3 centre, double radius);

    private static OrientedBox box(BoundedModel model, Pose at) {
        return OrientedBox.of(model.tree().box(), at);
    }
}
