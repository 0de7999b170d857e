/** Text, panels and the crosshair over the picture: a stroke font made here, its distance field and one draw. */
package nephele.engine.render.pass.overlay;
