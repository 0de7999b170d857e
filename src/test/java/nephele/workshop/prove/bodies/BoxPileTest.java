package nephele.workshop.prove.bodies;

import static org.junit.jupiter.api.Assertions.assertEquals;

import nephele.engine.level.Body;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** The piles equal those with which other engines were measured, draw by draw. */
class BoxPileTest {
    private static Body.Box box(BoxPile.Family family, int number, int index) {
        return BoxPile.of(family, number).bodies().get(index);
    }

    @Test
    void dropsAreTheSameDraws() {
        BoxPile pile = BoxPile.of(BoxPile.Family.DROP, 7);
        Body.Box top = box(BoxPile.Family.DROP, 7, 3);
        assertEquals(4, pile.bodies().size());
        assertEquals(6.5791984413496305, pile.heightMetres());
        assertEquals(new Vec3(0.0056364339668116045, 4.479198441349631, -0.07563171099816897), top.centre());
        assertEquals(new Vec3(.8, .2, .001), top.size());
        assertEquals(.001, top.massKilograms());
    }

    @Test
    void towersAreTheSameDraws() {
        Body.Box top = box(BoxPile.Family.TOWER, 2, 11);
        assertEquals(new Vec3(-5.415035966645143E-4, 4.612155062377832, 0.009024715337351875), top.centre());
        assertEquals(5601.1724, top.massKilograms(), 1e-3);
    }

    @Test
    void loadsAreTheSameDraws() {
        Body.Box load = box(BoxPile.Family.BIG, 599, 1);
        assertEquals(new Vec3(0.017018318904190883, 0.6136907958602177, -0.0018235810181408854), load.centre());
        assertEquals(.01, box(BoxPile.Family.BIG, 599, 0).massKilograms());
    }

    @Test
    void theRoomIsTheSame() {
        var room = BoxPile.of(BoxPile.Family.DROP, 0).room();
        assertEquals(6, room.size());
        assertEquals(new Aabb(-6, 6, -6, 6, 7, 6), room.collider(1).bounds());
        assertEquals(new Aabb(-7, -1, -7, 7, 7, -6), room.collider(4).bounds());
    }
}
