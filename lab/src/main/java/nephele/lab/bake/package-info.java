/** Bakes what a level would otherwise compute: its sky as six pictures, the light of the sky on its surfaces. */
package nephele.lab.bake;
