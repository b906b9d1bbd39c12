/** The program: what each room holds, and which may know which, stands in docs/architecture.md. */
package sunbeam.app;
