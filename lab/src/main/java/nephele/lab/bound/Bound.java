package nephele.lab.bound;

/** A bounding volume by which models are tested for contact, from the simplest to the surface itself. */
enum Bound {
    SPHERE {
        @Override
        boolean touch(BoundedModel a, Pose atA, BoundedModel b, Pose atB) {
            double distance = a.middle(atA).minus(b.middle(atB)).length();
            return distance <= (a.sphere().radius() + b.sphere().radius()) * (1 + SLACK);
        }
    },
    /** The box along the world's axes around the turned box of the model. */
    AXIS_ALIGNED_BOX {
        @Override
        boolean touch(BoundedModel a, Pose atA, BoundedModel b, Pose atB) {
            return box(a, atA).upright().overlaps(box(b, atB).upright());
        }
    },
    ORIENTED_BOX {
        @Override
        boolean touch(BoundedModel a, Pose atA, BoundedModel b, Pose atB) {
            return box(a, atA).touches(box(b, atB));
        }
    },
    /** Oriented boxes in a tree, down to that of each triangle. */
    HIERARCHY {
        @Override
        boolean touch(BoundedModel a, Pose atA, BoundedModel b, Pose atB) {
            return a.tree().touches(b.tree(), atB.seenFrom(atA), (own, other) -> true);
        }
    },
    /** The triangles themselves, found through the hierarchy. */
    TRIANGLES {
        @Override
        boolean touch(BoundedModel a, Pose atA, BoundedModel b, Pose atB) {
            return a.tree().touches(b.tree(), atB.seenFrom(atA), TrianglePair::touch);
        }
    };

    private static final double SLACK = 1e-9;

    /** Returns whether the volumes of two models have a point in common. */
    abstract boolean touch(BoundedModel a, Pose atA, BoundedModel b, Pose atB);

    private static OrientedBox box(BoundedModel model, Pose at) {
        return OrientedBox.of(model.tree().box(), at);
    }
}
